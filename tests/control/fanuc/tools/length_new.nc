%
O0001
(rule: F 4.2 a new H: the difference with its block)
(expect: #1=60)
(expect: #2=75)
(expect: #3=50)
G10L10P5R10.
G10L10P6R25.
G43H5Z50.
#1=#5023
H6
#2=#5023
G43H0
#3=#5023
M30
%
