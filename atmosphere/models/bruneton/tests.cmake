# Minutes under sanitizers, most of whose kernels the other tests run there.
set_property(TEST model_bruneton_test APPEND PROPERTY LABELS slow)
