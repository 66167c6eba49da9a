%
;rule: NC-210 2: # in front of a block makes it wait; / in front of it skips
;expect: path X5
;expect: E30=2
#E30=2
N10 #G0 X5.
M30
