%
O0001
G00 X0.
%
(expect: 4:1 PS5010 END OF RECORD: the end of the text is reached without M30 or M2)
(exit: 3)
