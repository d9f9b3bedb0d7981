-- | The version of the program.
module BlackHole.Cli.Version (versionLine) where

import BlackHole.Image.Metadata (software)
import BlackHole.Render.PixelArray (backendName)
import Data.Version (showVersion)
import System.Info (compilerName, compilerVersion)

-- | Name, version, compiler and array back end.
versionLine :: String
versionLine =
  software ++ " (" ++ compilerName ++ "-" ++ showVersion compilerVersion ++ ", "
    ++ backendName
    ++ " arrays)"
