%
O0001
(rule: F 2.3 G35, G36: a thread along an arc; F is the pitch along the longer way)
(expect: #1=-10)
G00X20.Z0
S300M03
G18G36X20.Z-10.R40.F2.
#1=#5003
M30
%
