#include "cli/commands.h"

int main(int argc, char** argv)
{
    return aeolic::runProgram(aeolic::programText, argc, argv, aeolic::addCommands);
}
