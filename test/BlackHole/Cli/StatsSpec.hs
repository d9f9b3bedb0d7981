module BlackHole.Cli.StatsSpec (spec) where

import BlackHole.Cli.Memory
import qualified Data.ByteString as Bytes
import Data.List (isInfixOf)
import Support.Json
import Support.Program (quietly)
import System.Directory (listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "--stats tells rays, workers and seed" $
    inFolder $ \folder -> do
      let file = folder </> "stats.json"
      quietly
        [ "render",
          "--width",
          "24",
          "--height",
          "10",
          "--samples",
          "3",
          "--noise",
          "0",
          "--seed",
          "18446744073709551615",
          "--threads",
          "1",
          "--stats",
          file,
          "-o",
          folder </> "a.png"
        ]
        `shouldReturn` ExitSuccess
      text <- readFile file
      mapM_
        (\part -> text `shouldSatisfy` isInfixOf part)
        [ "\"rays\": 720",
          "\"workers\": 1",
          "\"rows\": 10",
          "\"seed\": \"18446744073709551615\"",
          "\"not_finite_pixels\": 0"
        ]
  it "--stats holds no null, estimates with their errors, and measured bounds" $
    inFolder $ \folder -> do
      let file = folder </> "stats.json"
      quietly
        ["render", "--width", "40", "--samples", "2", "--stats", file, "-o", folder </> "a.png"]
        `shouldReturn` ExitSuccess
      text <- readFile file
      let at = foldl (\j name -> j >>= member name) (readJson text)
          number path = case at path of
            Just (Number n) -> n
            _ -> -1
      filter (("null" `isInfixOf`) . dropWhile (/= ':')) (lines text)
        `shouldBe` ["  \"first_not_finite_pixel\": null,"]
      number ["rays"] `shouldSatisfy` (>= 40 * 22 * 2)
      at ["rays_estimated"] `shouldBe` Just (Bool True)
      number ["estimates", "lines_of_sight"] `shouldSatisfy` (> 800)
      number ["estimates", "gas_samples", "total"] `shouldSatisfy` (> number ["rays"] / 2)
      number ["estimates", "steps", "total"]
        `shouldSatisfy` (>= number ["estimates", "gas_samples", "total"])
      number ["estimates", "steps", "standard_error"] `shouldSatisfy` (> 0)
      number ["error_bounds", "greatest_direction_error_radians"]
        `shouldSatisfy` (\e -> e > 0 && e < 1e-6)
      number ["error_bounds", "other_fates"] `shouldBe` 0
      mapM_
        (\stage -> number ["seconds", stage] `shouldSatisfy` (> 0))
        ["trace", "develop_and_write"]
  it "stops before rendering if the statistics can't be written" $
    inFolder $ \folder -> do
      quietly
        ["render", "--width", "24", "--stats", "/no/such/stats.json", "-o", folder </> "a.png"]
        `shouldReturn` ExitFailure 4
      listDirectory folder `shouldReturn` []
  it "--keep-partial and --strict change nothing about a picture that comes to its end" $
    inFolder $ \folder -> do
      let file name = folder </> name
      codes <-
        mapM
          quietly
          [ ["render", "--width", "40", "-o", file "a.png"],
            ["render", "--width", "40", "--keep-partial", "--strict", "-o", file "b.png"]
          ]
      codes `shouldBe` [ExitSuccess, ExitSuccess]
      expected <- Bytes.readFile (file "a.png")
      Bytes.readFile (file "b.png") `shouldReturn` expected
  it "knows the memory that it takes, where the system does" $
    peakMemory >>= (`shouldSatisfy` maybe True (> 1000000))
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
