%
;rule: NC-210 4, 13: what Kadr does not execute is passed over with a warning where it only costs time or a picture
;expect: E30=2
;expect: warning K5345 at 12:1
;expect: warning K5345 at 13:1
;expect: warning K5345 at 14:1
;expect: warning K5345 at 15:1
;expect: warning K5247 at 17:1
;expect: warning K5247 at 18:1
TMR=2
E30=2
G28
G29
G4
(DIS,E30,"mm")
(DIS," Time- ",E30,"  pass 3")
(DSA,1,X-10X10,Y-10Y10)
(CTL,T)
M30
