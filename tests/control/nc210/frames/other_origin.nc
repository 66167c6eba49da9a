%
;rule: NC-210 9: (UOT,n) of another origin than the one that acts is not read
;expect: alarm  K5018 at 5:1
(UAO,1)
(UOT,2,X60.)
M30
