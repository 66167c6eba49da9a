%
O0001
(rule: F 6.5, 6.9 a touch that went to its end is an alarm where the program says so)
(expect: alarm MC3001 K5450 at 7:31)
G90G94G54
G31X52.F100
IF[ABS[#5061-[52]]LT0.005]THEN#3000=1(PROBE DID NOT TRIGGER)
M30
%
