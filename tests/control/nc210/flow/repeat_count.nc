%
;rule: NC-210 12: (RPT,n) to (ERP) run n times, one inside of another
;expect: path X20 x40f100 x60 X20 x40 x60
;expect: E30=6
E30=0
G17 G71 G90 G94 S1000 M3
(RPT,2)
E31=20
G0 XE31
(RPT,2)
E31=E31+20
G1 XE31 F100.
(ERP)
E30=E30+3
(ERP)
M30
