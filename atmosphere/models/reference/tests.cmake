# Minutes under sanitizers, most of whose kernels the other tests run there.
set(labels slow)
set(cost 60)
