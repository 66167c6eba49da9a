%
PROGRAM MAIN
(rule: 5 variables that a program names itself: of its level, or of the whole run behind the sign _)
(expect: #<DEPTH>=5)
(expect: #<_COUNT>=7)
(expect: #31=1)
(expect: path X6 Y-5)
#<De pth>=5
#<_count>=5
CALL P1
G0 X[#<depth>+1]
Y[0-#<depth>]
M2
PROGRAM P1
#<depth>=99
#<_count>=[#<_count>+2]
#31=[#<depth> EQ 99]
RTS
%
