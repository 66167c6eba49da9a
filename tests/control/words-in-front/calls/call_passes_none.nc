%
PROGRAM MAIN
(rule: 4 no passes at all are an alarm)
(expect: alarm  K5438 at 5:13)
CALL COUNT Q0
M2
PROGRAM COUNT
RTS
%
