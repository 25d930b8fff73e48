set(cost 75)
