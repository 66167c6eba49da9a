%
O0001
(rule: F 6.2 #[expression] is rounded to a whole number)
(expect: #100=5)
(expect: #101=6)
(expect: #102=7)
(expect: #3=7)
#1=100
#[#1]=5
#[#1+1.4]=6
#[#1+1.5]=7
#3=#[#1+2]
M30
%
