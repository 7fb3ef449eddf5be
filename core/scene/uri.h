// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace etak {

// URIs as glTF uses them: a file beside the document, or the data themselves. `place` is for messages
// ("scene.gltf#/images/0/uri"); all throw Error.

/// The file that a relative URI names, with percent escapes decoded. Refuses a scheme ("https:", "file:"), an
/// absolute path, any ".." (before or after decoding), NUL, and an empty URI.
std::string file_of_uri(std::string_view uri, std::string_view place);

/// The bytes of a "data:" URI (base64 or percent-escaped); none for any other URI.
std::optional<std::string> data_of_uri(std::string_view uri, std::string_view place);

/// A file name as a URI: everything but letters, digits and -._~/ is escaped.
std::string uri_of_file(std::string_view file);

}  // namespace etak
