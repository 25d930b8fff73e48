set(cost 70)
