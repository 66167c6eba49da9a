// antlr4-runtime.h — the parts of ANTLR's runtime that Kadr, its tests and its generated parser
// use.
//
// The generated files include a header of this name, and this folder is searched before ANTLR's
// own: that one brings in everything, among it misc/InterpreterDataReader.h, which is no valid C++
// for Clang (it constructs a class by a deleted constructor).
#pragma once

// This one first: the others take their forward declarations from it.
#include "antlr4-common.h"
// The parts.
#include "ANTLRInputStream.h"
#include "BailErrorStrategy.h"
#include "BaseErrorListener.h"
#include "DefaultErrorStrategy.h"
#include "FailedPredicateException.h"
#include "InputMismatchException.h"
#include "Lexer.h"
#include "NoViableAltException.h"
#include "Parser.h"
#include "ParserRuleContext.h"
#include "TokenStream.h"
#include "Vocabulary.h"
#include "atn/ATN.h"
#include "atn/ATNDeserializer.h"
#include "atn/ATNState.h"
#include "atn/LexerATNSimulator.h"
#include "atn/ParserATNSimulator.h"
#include "atn/PredictionContext.h"
#include "atn/Transition.h"
#include "dfa/DFA.h"
#include "misc/IntervalSet.h"
#include "tree/TerminalNode.h"
