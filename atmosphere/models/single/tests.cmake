set(cost 30)
