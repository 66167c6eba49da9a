%
;rule: NC-210 13: (DIS,"text") shows a text; (DLY,t) waits
;expect: message LOAD THE PART
;expect: dwell 1.5
(DIS,"LOAD THE PART")
#(DLY,1.5)
(UCG,2, X-120.0 X124.0 , Y-140.0 Y143.0 ,Z)
M30
