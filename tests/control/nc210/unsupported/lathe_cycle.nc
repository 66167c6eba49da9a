%
;rule: NC-210 16: cycles of three letters are refused by name
;expect: alarm  K5018 at 4:1
(FIL,Z-20,K2)
M30
