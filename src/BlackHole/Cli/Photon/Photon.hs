-- | @blackhole photon@: reports on one light path.
module BlackHole.Cli.Photon.Photon (photon) where

import BlackHole.Cli.Console (succeeded)
import BlackHole.Cli.ExitStatus
import BlackHole.Cli.Photon.Options
import BlackHole.Cli.Photon.Report
import BlackHole.Image.AtomicFile
import Control.Monad (unless)
import GHC.Clock (getMonotonicTime)

-- | Prints the report on the path that the options describe, and writes its points to a
-- file if they ask for it.
photon :: PhotonOptions -> IO ExitStatus
photon options = case resolvePhoton options of
  Left problems -> complainAll UsageError problems
  Right task -> do
    start <- getMonotonicTime
    let outcome = photonOutcome task
        points = show (length (outcomePoints outcome)) ++ " points"
    written <-
      maybe
        (pure (Right ()))
        (`writeFileAtomically` outcomeCsv outcome)
        (photonPath options)
    case written of
      Left problem -> complain CannotWrite ("--path: " ++ renderWriteProblem problem)
      Right () -> do
        unless (photonQuiet options) $
          mapM_ (\file -> succeeded start file points) (photonPath options)
        printed Done (outcomeText (photonJson options) outcome)
