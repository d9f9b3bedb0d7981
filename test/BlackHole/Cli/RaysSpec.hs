module BlackHole.Cli.RaysSpec (spec) where

import BlackHole.Cli.Rays
import BlackHole.Figure.RayFan
import BlackHole.Scene.Problem
import BlackHole.Spacetime.Kerr.Landmarks (noSpin, spin)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Characters
import Options.Applicative
import Test.Hspec

spec :: Spec
spec = do
  it "draws the default figure as SVG" $
    resolve [] `shouldBe` Just (Right (RaysTask Svg defaultRayFan))
  it "goes by the file's ending, in any case" $
    resolve ["-o", "a/b.PNG", "--rays", "9", "--extent", "5", "--width", "300"]
      `shouldBe` Just (Right (RaysTask Png (RayFan 9 5 300 noSpin)))
  it "takes a spin" $
    resolve ["--spin", "-0.9"]
      `shouldBe` Just (Right (RaysTask Svg (maybe defaultRayFan (RayFan 31 8 1200) (spin (-0.9)))))
  it "draws spin 0 as no spin, byte for byte" $
    (fmap raysFile <$> resolve ["--spin", "0"])
      `shouldBe` Just (Right (raysFile (RaysTask Svg defaultRayFan)))
  it "writes what the ending says" $ do
    Lazy.take 4 (raysFile (RaysTask Png small)) `shouldBe` Lazy.pack [0x89, 0x50, 0x4e, 0x47]
    Characters.take 5 (raysFile (RaysTask Svg small)) `shouldBe` Characters.pack "<?xml"
  it "writes the same bytes every time" $
    raysFile (RaysTask Png small) `shouldBe` raysFile (RaysTask Png small)
  describe "mistakes name the option and the value" $ do
    refuses ["--rays", "0"] [("--rays", "0")]
    refuses ["--rays=-3", "--extent", "1"] [("--rays", "-3"), ("--extent", "1")]
    refuses ["--extent", "nan"] [("--extent", "NaN")]
    refuses ["--width", "100000"] [("--width", "100000")]
    refuses ["--spin", "1"] [("--spin", "1")]
    refuses ["--spin", "0.5", "--extent", "4"] [("--extent", "4")]
    refuses ["-o", "rays.gif"] [("--output", "'rays.gif'")]
    refuses ["-o", ""] [("--output", "''")]
  where
    small = RayFan 9 5 200 noSpin
    resolve arguments =
      resolveRays
        <$> getParseResult (execParserPure defaultPrefs (info raysOptions mempty) arguments)
    refuses arguments problems =
      it (unwords ("rays" : arguments)) $
        case resolve arguments of
          Just (Left found) ->
            map (\p -> (problemOption p, problemValue p)) found `shouldBe` problems
          _ -> expectationFailure "taken"
