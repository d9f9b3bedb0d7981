-- | The program: from its arguments to its exit code.
module BlackHole.Cli.Run (run) where

import BlackHole.Cli.Animate.Animate (animate)
import BlackHole.Cli.Console (message, say)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Explore.Explore (explore)
import BlackHole.Cli.Help (CommandHelp (commandName))
import BlackHole.Cli.Join (join)
import BlackHole.Cli.Options
import BlackHole.Cli.Photon.Photon (photon)
import BlackHole.Cli.Rays (rays)
import BlackHole.Cli.Render.Render (render)
import BlackHole.Cli.SceneCommand (runSceneCommand)
import BlackHole.Cli.SelfTest (selfTest)
import BlackHole.Cli.Version (versionLine)
import Control.Exception
  ( SomeAsyncException (..),
    SomeException,
    displayException,
    fromException,
    throwIO,
    try,
  )
import System.Exit (ExitCode (..))

-- | Runs the program with its arguments. Every failure is reported in one line on
-- standard error and by the exit code.
run :: [String] -> IO ExitCode
run arguments = do
  outcome <- try (dispatch arguments)
  case outcome of
    Right status -> pure (exitCode status)
    Left failure
      | Just (SomeAsyncException _) <- fromException failure -> throwIO failure
      | otherwise ->
        exitCode
          <$> complain InternalFault (unwords (lines (displayException (failure :: SomeException))))

dispatch :: [String] -> IO ExitStatus
dispatch arguments
  | Just answer <- completion versionLine arguments = answer >>= printed Done
  | otherwise =
    mapM_ say (formerOptionWarnings arguments) >> case parseArguments versionLine arguments of
      Inform text -> printed Done (text ++ "\n")
      Unnamed text -> UsageError <$ message (text ++ "\n")
      Misused line ->
        complain
          UsageError
          (line ++ " (see: " ++ unwords ("blackhole help" : named) ++ ")")
      Run command -> runCommand command
  where
    -- What help itself cannot find is in the list of all commands and topics.
    named = filter (`elem` filter (/= "help") (map commandName commandHelps)) (take 1 arguments)

runCommand :: Command -> IO ExitStatus
runCommand command = case command of
  Render options -> render options
  Join options -> join options
  Animate options -> animate options
  Explore options -> explore options
  Scenes task -> runSceneCommand task
  Photon options -> photon options
  Rays options -> rays options
  SelfTest options -> selfTest options
