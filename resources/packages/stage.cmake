# SPDX-License-Identifier: Apache-2.0
# Adds to the installed files of each component what only a Debian package holds. CPack runs it before it makes the
# packages. Times are those of SOURCE_DATE_EPOCH, so that the same source gives the same bytes.
cmake_policy(VERSION 3.24)

# compress(FILE): gzip without name and time.
function(compress file)
  execute_process(COMMAND gzip -9 -n -f ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr/share)
  set(doc ${share}/doc/${package})
  configure_file(${CPACK_ETAK_SOURCE}/resources/packages/copyright ${doc}/copyright COPYONLY)
  file(WRITE ${doc}/changelog.Debian "etak (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Built from the source by ./dev packages. What has changed for users is
    told by resources/doc/changelog.md of the source.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  compress(${doc}/changelog.Debian)
  file(GLOB pages ${share}/man/man1/*.1)
  foreach(page IN LISTS pages)
    compress(${page})
  endforeach()
  configure_file(${CPACK_ETAK_SOURCE}/resources/packages/lintian-overrides ${share}/lintian/overrides/${package} COPYONLY)
  # The modes of files do not depend on the umask of who builds.
  file(GLOB_RECURSE made LIST_DIRECTORIES true ${share}/doc/* ${share}/man/* ${share}/lintian/*)
  foreach(path IN LISTS made)
    if(IS_DIRECTORY ${path})
      file(CHMOD ${path} DIRECTORY_PERMISSIONS
        OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    else()
      file(CHMOD ${path} FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    endif()
  endforeach()
endforeach()
