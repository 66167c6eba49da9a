%
O0001
(rule: F 6.8 No.6007#1, #2: S calls O9029, #147 is its number; B calls O9028 with #146)
(expect: #100=1000)
(expect: #101=90)
(expect: #102=500)
(expect: #103=2)
(expect: to X10 F100)
S1000
#100=#147
B90
#101=#146
G01 X10. F100 S500 (SPEED)
#102=#147
M30
O9028
M99
O9029
#103=#103+1
S#147M03
M99
%
