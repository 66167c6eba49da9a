%
O0001
G93 G01 X10. F2.
X20.
M30
%
(expect: 4:1 PS1202 NO F COMMAND AT G93: this block has no F of its own under inverse time feed)
(exit: 3)
