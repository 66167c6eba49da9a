%
;rule: NC-210 9: (UOT,n,…) shifts the origin that acts, (URT,a) turns and replaces, (URT,0) ends it
;expect: path X70Y45 X60Y50 X10Y5
(UAO,1)
G0 X0 Y0
(UOT,1,X60.,Y40.)
E25=90
G0 X10. Y5.
(URT,45)
(URT,E25)
G0 X10. Y0
(URT,0)
(UOT,1,X0,Y0)
G0 X10. Y5.
M30
