-- | The results of a run, their exit codes, and the complaints that go with them.
module BlackHole.Cli.ExitStatus
  ( ExitStatus (..),
    exitCode,
    complain,
    complainAll,
    printed,
    outputProblemText,
  )
where

import BlackHole.Cli.Console
import BlackHole.Scene.Problem (Problem, renderProblem)
import System.Exit (ExitCode (..))

-- | The result of a run.
data ExitStatus
  = -- | Success.
    Done
  | -- | An internal error.
    InternalFault
  | -- | Invalid command line.
    UsageError
  | -- | An invalid scene, or an input file that cannot be read.
    BadInput
  | -- | The output cannot be written.
    CannotWrite
  | -- | Frames of an animation or its video file are missing.
    Unfinished
  deriving (Eq, Show, Enum, Bounded)

-- | The table of exit codes.
exitCode :: ExitStatus -> ExitCode
exitCode status = case status of
  Done -> ExitSuccess
  InternalFault -> ExitFailure 1
  UsageError -> ExitFailure 2
  BadInput -> ExitFailure 3
  CannotWrite -> ExitFailure 4
  Unfinished -> ExitFailure 5

-- | Prints a message on standard error and returns the status.
complain :: ExitStatus -> String -> IO ExitStatus
complain status line = status <$ say line

-- | 'complain' for every problem.
complainAll :: ExitStatus -> [Problem] -> IO ExitStatus
complainAll status problems = status <$ mapM_ (say . renderProblem) problems

-- | Prints a result on standard output and returns the status if that succeeds. A reader
-- that has ended gets no message.
printed :: ExitStatus -> String -> IO ExitStatus
printed status text = printText text >>= either failed (const (pure status))
  where
    failed ReaderGone = pure CannotWrite
    failed problem = complain CannotWrite (outputProblemText problem)

-- | The problem in one line.
outputProblemText :: OutputProblem -> String
outputProblemText problem =
  "cannot write to standard output: " ++ case problem of
    ReaderGone -> "its reader has ended"
    OutputRefused reason -> reason
