// Kadr.g4: the grammar of the Kadr language.
//
// Everything alphanumeric is an Identifier to the lexer. Before the parser sees the tokens, the
// compiler retypes them (compiler/syntax/retype.cpp): keywords by the lexeme table of the file's
// keyword language, words of NC blocks by the input dialect, names of types, `{` that opens a value
// instead of a block. The token kinds that only exist after that step are listed in `tokens`.
//
// Nearly every decision is made by looking at one token. The others: the head of a `for` needs three,
// a `,` that may end a list in braces needs two, and an `else` belongs to the nearest `if`, as in C.
// Operators are a flat list; their precedence is C's and stands in one table
// (compiler/syntax/operators.h).
grammar Kadr;

tokens {
    If, Else, While, Do, For, Switch, Case, Default, Break, Continue, Return,
    Struct, Enum, Import, Const, Auto, With, True, False,
    Cycle, Program, Contour, Curve, Over, Test, Property, Preserves, Frames, In,
    Note, Raw, Units, Require, Assert, ErrorWord, Warn, Expect, Assume, Close, Language, Dialect,
    Given, Contains,
    TypeName,      // `length` in front of a name: `length r`
    GenericName,   // `table` in `table<hole>("f.csv")`
    ArgumentName,  // `to` in `drill(to: 5mm)`
    LiteralWord,   // `X10`, `X-5.25mm`, `G54.1`
    BareWord,      // `TRANS`
    Address,       // `X` in `X=r`
    Mode,          // `AC` and `IC` in `I=AC(5)`
    OpenValue,     // `{` of `{10mm, 20mm}`
    RawText,       // `{ … }` behind `raw`
    NoArgument,    // what a call of the control leaves out: `CYCLE81(50,2,,-10)`
    TextOpen,      // `"abc {`
    TextMiddle,    // `} abc {`
    TextClose,     // `} abc"`
    Format         // `:.3` in `"{x:.3}"`
}

// ---------------------------------------------------------------- declarations

file : declaration* EOF ;

declaration
    : Language Identifier ';'                                             # languageDeclaration
    | Dialect dialectName ';'                                             # dialectDeclaration
    | Units Identifier ';'                                                # unitsDeclaration
    | Import importPath ';'                                               # importDeclaration
    | Include                                                             # includeDeclaration
    | Struct Identifier '{' field* '}'                                    # structDeclaration
    | Enum Identifier '{' (enumerator (',' enumerator)* ','?)? '}'        # enumDeclaration
    | Curve Identifier parameters Over type Identifier '=' range block    # curveDeclaration
    | Test text block                                                     # testDeclaration
    | Property text parameters block                                      # propertyDeclaration
    | Cycle Identifier parameters preserves? block                        # cycleDeclaration
    | Program Identifier parameters preserves? block                      # programDeclaration
    | Contour Identifier '=' block ';'                                    # contourDeclaration
    | Const variable                                                      # constantDeclaration
    | Auto Identifier '=' expression ';'                                  # autoDeclaration
    | type Identifier definition                                          # typedDeclaration
    | ';'                                                                 # emptyDeclaration
    ;

definition
    : parameters block                                                    # functionDefinition
    | ('=' expression)? ';'                                               # variableDefinition
    ;

variable
    : Auto Identifier '=' expression ';'                                  # autoVariable
    | type Identifier ('=' expression)? ';'                               # typedVariable
    ;

dialectName : Identifier ('-' Identifier)* | text ;
importPath : Identifier ('.' Identifier)* | text ;
field : type Identifier ('=' expression)? ';' ;
enumerator : Identifier ('=' expression)? ;
parameters : '(' (parameter (',' parameter)*)? ')' ;
parameter : type Identifier ('=' expression | In range)? ;
preserves : Preserves preserved (',' preserved)* ;
preserved : LiteralWord | BareWord | Address | Frames ;
type : TypeName ('[' expression? ']')? '?'? '&'? ;

// ---------------------------------------------------------------- statements

block : '{' statement* '}' ;

statement
    : block                                                               # blockStatement
    | ';'                                                                 # emptyStatement
    | If '(' condition ')' statement (Else statement)?                    # ifStatement
    | While '(' condition ')' statement                                   # whileStatement
    | Do statement While '(' condition ')' ';'                            # doStatement
    | For '(' forHead ')' statement                                       # forStatement
    | Switch '(' expression ')' '{' switchCase* '}'                       # switchStatement
    | Break ';'                                                           # breakStatement
    | Continue ';'                                                        # continueStatement
    | Return expression? ';'                                              # returnStatement
    | Const variable                                                      # constantStatement
    | variable                                                            # variableStatement
    | Contour Identifier '=' block ';'                                    # contourStatement
    | skip? word+ (point word* (point word*)?)? ';'                                # wordsStatement
    | With modal (','? modal)* block                                      # withStatement
    | Note expression ';'                                                 # noteStatement
    | Raw (RawText | expression ';')                                      # rawStatement
    | Units Identifier ';'                                                # unitsStatement
    | Require '(' condition (',' expression)? ')' ';'                     # requireStatement
    | Assert '(' condition (',' expression)? ')' ';'                      # assertStatement
    | ErrorWord '(' expression ')' ';'                                    # errorStatement
    | Warn '(' expression ')' ';'                                         # warnStatement
    | Expect '(' condition ')' ';'                                        # expectStatement
    | Assume '(' condition ')' ';'                                        # assumeStatement
    | Close ';'                                                           # closeStatement
    | assignment ';'                                                      # expressionStatement
    ;

forHead
    : Const? (type | Auto) Identifier ':' range                           # forEachHead
    | forStart? ';' condition? ';' assignment?                            # forCountHead
    ;

forStart
    : (type | Auto) Identifier '=' expression                             # forDeclaration
    | assignment                                                          # forAssignment
    ;

switchCase : (Case range (',' range)* | Default) ':' statement* ;

// ---------------------------------------------------------------- words of NC blocks

skip : '/' Number? ;

word
    : LiteralWord                                                         # literalWord
    | BareWord                                                            # bareWord
    | Address ('=' | '+=' | '-=') wordValue                               # addressedWord
    ;

wordValue
    : Mode '(' expression ')'                                             # modeValue
    | expression                                                          # plainValue
    ;

// The target of `G1 p;`, and `orient(…)` beside it. Each begins with a name or a `{`, so that it
// cannot continue the value of the word before it.
point : pointStart (('+' | '-' | '*' | '/') operand)* ;

pointStart
    : Identifier suffix*                                                  # namedPoint
    | OpenValue (argument (',' argument)* ','?)? '}'                      # valuePoint
    ;

modal
    : word                                                                # modalWord
    | Identifier '(' arguments? ')'                                       # modalFrame
    ;

// ---------------------------------------------------------------- expressions

assignment
    : expression
      (('=' | '+=' | '-=' | '*=' | '/=' | '%=' | '<<=' | '>>=' | '&=' | '^=' | '|=') expression)?
    ;

// `=` is let in so that the message can say what is meant.
condition : expression ('=' expression)? ;

range : expression ('..' expression)? ;

expression
    : operand
      ( ( '*' | '/' | '%' | '+' | '-' | '<<' | '>>' | '<' | '<=' | '>' | '>=' | Contains | '==' | '!='
        | '&' | '^' | '|' | '&&' | '||' | '??' ) operand )*
      ('?' expression ':' expression)?
    ;

operand : ('-' | '+' | '!' | '~' | '++' | '--')* primary suffix* ;

primary
    : Number                                                              # number
    | (True | False)                                                      # truth
    | text                                                                # textValue
    | Identifier                                                          # name
    | GenericName '<' type '>' '(' arguments? ')'                         # genericCall
    | Given Identifier                                                    # given
    | '(' expression ')'                                                  # parentheses
    | OpenValue (argument (',' argument)* ','?)? '}'                      # braces
    ;

suffix
    : '(' arguments? ')'                                                  # call
    | '[' expression ']'                                                  # index
    | '.' Identifier                                                      # member
    | ('++' | '--')                                                       # postfixStep
    ;

arguments : argument (',' argument)* ;
argument : (ArgumentName ':')? expression | NoArgument ;

text
    : Text                                                                # plainText
    | TextOpen formatted (TextMiddle formatted)* TextClose                # formattedText
    ;
formatted : expression Format? ;

// ---------------------------------------------------------------- tokens

OpenParen : '(' ;      CloseParen : ')' ;
OpenBracket : '[' ;    CloseBracket : ']' ;
OpenBrace : '{' ;      CloseBrace : '}' ;
Semicolon : ';' ;      Comma : ',' ;
Colon : ':' ;          Question : '?' ;       Coalesce : '??' ;
Dot : '.' ;            DotDot : '..' ;
Plus : '+' ;           Minus : '-' ;          Star : '*' ;           Slash : '/' ;
Percent : '%' ;        PlusPlus : '++' ;      MinusMinus : '--' ;
Assign : '=' ;         PlusAssign : '+=' ;    MinusAssign : '-=' ;
StarAssign : '*=' ;    SlashAssign : '/=' ;   PercentAssign : '%=' ;
ShiftLeftAssign : '<<=' ; ShiftRightAssign : '>>=' ;
AndAssign : '&=' ;     XorAssign : '^=' ;     OrAssign : '|=' ;
Equal : '==' ;         NotEqual : '!=' ;
Less : '<' ;           LessEqual : '<=' ;     Greater : '>' ;        GreaterEqual : '>=' ;
ShiftLeft : '<<' ;     ShiftRight : '>>' ;
AndAnd : '&&' ;        OrOr : '||' ;          Not : '!' ;
And : '&' ;            Or : '|' ;             Xor : '^' ;            Tilde : '~' ;

// The blocks of letters in Unicode's first plane. `\p{L}` says it exactly, in seven hundred pieces that
// ANTLR unpacks whenever any command starts: two thirds of the time of a short run.
fragment Letter : [A-Za-z_\u00AA\u00B5\u00BA\u00C0-\u00D6\u00D8-\u00F6\u00F8-\u02FF\u0370-\u1FFF\u2C00-\u2DFF\u3040-\uD7FF] ;
fragment LaterLetter : Letter | [0-9\u0300-\u036F] ;
Identifier : Letter LaterLetter* ;
Number : ([0-9]+ ('.' [0-9]+)? | '.' [0-9]+) ([eE] [+\-]? [0-9]+)? ;
Text : '"' ('\\' ~[\r\n] | ~["\\\r\n])* '"' ;
TextUnclosed : '"' ('\\' ~[\r\n] | ~["\\\r\n])* ;
TextWrongQuotes
    : '\'' ~['\r\n]* '\''
    | [\u201C\u201E] ~[\u201C\u201D\r\n]* [\u201C\u201D]
    | '\u00AB' ~[\u00BB\r\n]* '\u00BB'
    ;
Include : '#' [ \t]* 'include' ~[\r\n]* ;
LineComment : '//' ~[\r\n]* ;
BlockComment : '/*' .*? '*/' ;
CommentUnclosed : '/*' ;
Space : [ \t\r\n\f\u00A0\uFEFF]+ -> skip ;
Unknown : . ;
