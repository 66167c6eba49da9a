%
;rule: NC-210 7: K beside an arc is the pitch of a helix, which is not read
;expect: alarm  K5010 at 6:24
G17 G71 G90 G94 S1000 M3
G0 X10. Y0 Z0
G3 X10. Y0 I0 J0 Z-12. K4. F100.
M30
