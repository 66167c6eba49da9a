%
;rule: NC-210 12: a branch to a label that is not there
;expect: alarm  K5431 at 4:6
(BNC,NOWHER)
M30
