%
;rule: NC-210 11: functions have degrees; ART has one argument
;expect: E30=20
;expect: E31=45
;expect: E32=4
;expect: E33=3
E30=40.*COS(60)
E31=ART((5)/(5))
E32=SQR(5*5-3*3)
E33=INT(3.9)
M30
