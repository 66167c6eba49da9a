%
O0001
(rule: F 6.4 a main program that ends with M99 begins again: numbered blocks behind it that only raise an alarm are no way out of a loop of its own)
(expect: warning K5900 at 9:1)
(expect: #500=1)
#500=#500+1
IF[#500GT500.]GOTO9
G0X2.
M99
N9#3000=1(TOO FAR)
%
