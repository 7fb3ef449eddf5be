Signature: 8a477f597d28d172789f06886806bc55
# etak-cache
# The results in this folder are made again where they are missing: it may be removed at any time.
