%
;rule: NC-210 9: (UIO,…) is added to the origin that acts, in a loop each time
;expect: path Z-2 Z-4
(UAO,1)
(RPT,2)
(UIO,Z-2.)
G0 Z0
(ERP)
M30
