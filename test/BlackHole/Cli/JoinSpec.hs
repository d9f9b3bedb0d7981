module BlackHole.Cli.JoinSpec (spec) where

import BlackHole.Cli.Join
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import Data.Either (fromLeft)
import Data.List (isInfixOf)
import Support.Program (quietly)
import Support.Tool
import System.Directory (doesFileExist)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "makes the file that one quietly makes, byte for byte" . inFolder $ \folder -> do
    quietly (small ++ ["-o", folder </> "whole.png"]) `shouldReturn` ExitSuccess
    mapM_ (\i -> tile folder small i 3 `shouldReturn` ExitSuccess) [1 .. 3]
    quietly
      [ "join",
        folder </> "2.tile",
        folder </> "3.tile",
        folder </> "1.tile",
        "-o",
        folder </> "joined.png"
      ]
      `shouldReturn` ExitSuccess
    whole <- Bytes.readFile (folder </> "whole.png")
    Bytes.readFile (folder </> "joined.png") `shouldReturn` whole
  it "does so in every format, and with bloom" . inFolder $ \folder -> do
    let same arguments coding extension = do
          quietly (plain ++ arguments ++ coding ++ ["-o", folder </> "whole" ++ extension])
            `shouldReturn` ExitSuccess
          mapM_ (\i -> tile folder (plain ++ arguments) i 2 `shouldReturn` ExitSuccess) [1, 2]
          quietly
            ( [ "join",
                folder </> "1.tile",
                folder </> "2.tile",
                "-o",
                folder </> "joined" ++ extension
              ]
                ++ coding
            )
            `shouldReturn` ExitSuccess
          whole <- Bytes.readFile (folder </> "whole" ++ extension)
          Bytes.readFile (folder </> "joined" ++ extension) `shouldReturn` whole
    same [] ["--bits", "16"] ".png"
    same ["--bloom", "0.1"] [] ".png"
    same [] ["--bits", "32"] ".exr"
    same ["--bloom", "0.2"] ["--bits", "16"] ".png"
    same ["--bloom", "0.1"] [] ".hdr"
    same ["--bloom", "0.1"] [] ".tif"
    same ["--bloom", "0.1"] ["--bits", "32"] ".tif"
    same [] ["--quality", "80"] ".jpg"
  it "makes the same OpenEXR layers, numbers of samples included" . inFolder $ \folder ->
    forM_ ["--samples 3", "--samples 4 --noise 0.02 --bloom 0.1"] $ \sampling -> do
      let arguments = ["render", "--width", "40"] ++ words sampling
      quietly (arguments ++ ["-o", folder </> "whole.exr"]) `shouldReturn` ExitSuccess
      mapM_ (\i -> tile folder arguments i 3 `shouldReturn` ExitSuccess) [1 .. 3]
      quietly
        [ "join",
          folder </> "1.tile",
          folder </> "2.tile",
          folder </> "3.tile",
          "-o",
          folder </> "joined.exr"
        ]
        `shouldReturn` ExitSuccess
      quietly
        [ "render",
          "--from",
          folder </> "joined.exr",
          "--threads",
          "2",
          "--keep-partial",
          "-o",
          folder </> "again.exr"
        ]
        `shouldReturn` ExitSuccess
      whole <- Bytes.readFile (folder </> "whole.exr")
      mapM (Bytes.readFile . (folder </>)) ["joined.exr", "again.exr"] `shouldReturn` [whole, whole]
      withTool "exrheader" $ \tool -> do
        text <- toolOutput tool [folder </> "whole.exr"]
        forM_ ["deflection.V", "radius.V", "redshift.V", "samples.V"] $ \name ->
          text
            `shouldSatisfy` Bytes.isInfixOf
              (Characters.pack (name ++ ", 32-bit floating-point, sampling 1 1"))
  it "names tiles that are missing, of another scene, or damaged" . inFolder $ \folder -> do
    mapM_ (\i -> tile folder plain i 3) [1 .. 3]
    let paths = [folder </> (show i ++ ".tile") | i <- [1 .. 3 :: Int]]
        complaints = fmap (fromLeft []) . openTiles
    complaints (drop 1 paths) `shouldReturn` ["tile 1/3 is missing"]
    _ <- tile folder (plain ++ ["--inclination", "70"]) 2 3
    complaints paths
      `shouldReturn` [ folder </> "2.tile belongs to another picture than "
                         ++ folder </> "1.tile: inclination: 70 instead of inclination: 77"
                     ]
    _ <- tile folder plain 2 3
    bytes <- Bytes.readFile (folder </> "2.tile")
    let (start, end) = Bytes.splitAt (Bytes.length bytes - 1000) bytes
    Bytes.writeFile
      (folder </> "2.tile")
      (start <> Bytes.map (+ 1) (Bytes.take 1 end) <> Bytes.drop 1 end)
    complaints paths `shouldReturn` [folder </> "2.tile: damaged; render this tile again"]
    Bytes.writeFile (folder </> "2.tile") start
    complaints paths >>= (`shouldSatisfy` any ("incomplete" `isInfixOf`))
    complaints (paths ++ [folder </> "4.tile"])
      >>= (`shouldSatisfy` any ("cannot be read" `isInfixOf`))
    quietly ("join" : "-o" : (folder </> "joined.png") : paths) `shouldReturn` ExitFailure 3
    doesFileExist (folder </> "joined.png") `shouldReturn` False
  it "wants tile files to be called so, and no more tiles than rows" . inFolder $ \folder -> do
    quietly (plain ++ ["--tile", "1/2", "-o", folder </> "a.png"]) `shouldReturn` ExitFailure 2
    quietly (plain ++ ["--tile", "3/2", "-o", folder </> "a.tile"]) `shouldReturn` ExitFailure 2
    tile folder plain 1 19 `shouldReturn` ExitFailure 2
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    small = ["render", "--width", "24", "--samples", "1"]
    plain =
      ["render", "--width", "32", "--samples", "1", "--no-gravity", "--no-disk", "--sky", "grid"]
    tile folder arguments i n =
      quietly
        ( arguments
            ++ [ "--tile",
                 show (i :: Int) ++ "/" ++ show (n :: Int),
                 "-o",
                 folder </> (show i ++ ".tile")
               ]
        )
