%
;rule: NC-210 11: a formula needs a parameter of its own first
;expect: fix a word takes one variable: give it the value in a block of its own first
;expect: alarm  K5401 at 6:5
E30=12.
G0 X(E30+1)
M30
