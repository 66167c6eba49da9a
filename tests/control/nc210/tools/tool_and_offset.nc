%
;rule: NC-210 6: T4.04 is tool 4 with offset 4; without a number behind the point there is no offset
;expect: path X10
(UAO,1)
T1.1 M6
T2.02 M6
T3. M6
G0 X10.
M30
