%
O0001
G65 P9100 I1. I2. I3. I4. I5. I6. I7. I8. I9. I10. I11.
M30
%
(expect: 3:52 PS1095 TOO MANY TYPE-2 ARGUMENT: `I` begins one more round)
(exit: 3)
