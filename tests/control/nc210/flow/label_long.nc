%
;rule: NC-210 2: a label has six characters at most
;expect: alarm  K5502 at 4:2
"TOOLONG"
M30
