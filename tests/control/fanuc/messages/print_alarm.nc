%
O0001
(rule: F 6.9 what stands behind an alarm is not printed)
(expect: print [A])
(expect: alarm MC3001 K5450 at 8:1)
POPEN
DPRNT[A]
#3000=1(STOP)
DPRNT[B]
PCLOS
M30
%
