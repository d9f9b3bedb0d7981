module BlackHole.Cli.RunSpec (spec) where

import BlackHole.Cli.Run
import BlackHole.Image.File (fileLabel)
import BlackHole.Image.Label (Label (..))
import BlackHole.Light.Radiance (luminance)
import qualified BlackHole.Light.Radiance as Radiance
import Codec.Picture
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters
import System.Directory (listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  describe "blackhole render" $ do
    it "writes a PNG with the shadow, the disk arched over it, and stars" $
      inFolder $ \folder -> do
        let file = folder </> "hole.png"
        run ["render", "--width", "160", "--fov", "40", "--samples", "1", "-o", file] `shouldReturn` ExitSuccess
        listDirectory folder `shouldReturn` ["hole.png"]
        decoded <- readPng file
        case convertRGB8 <$> decoded of
          Left problem -> expectationFailure problem
          Right picture -> do
            (imageWidth picture, imageHeight picture) `shouldBe` (160, 90)
            -- The shadow's middle lies a little above the picture's, where the
            -- near side of the disk does not cover it.
            brightness picture 80 40 `shouldSatisfy` (< 0.02)
            -- Going up from there: the shadow, then the disk's far side.
            maximum [brightness picture 80 y | y <- [15 .. 35]] `shouldSatisfy` (> 0.3)
            -- Going down: the disk's near side.
            maximum [brightness picture 80 y | y <- [45 .. 60]] `shouldSatisfy` (> 0.3)
    it "writes equal bytes for any number of threads" $
      inFolder $ \folder -> do
        let picture n = do
              let file = folder </> (show n ++ ".png")
              code <- run ["render", "--width", "64", "--threads", show (n :: Int), "-o", file]
              bytes <- Bytes.readFile file
              pure (code, bytes)
        one <- picture 1
        two <- picture 2
        two `shouldBe` one
    it "renders a picture of any format again from the picture, byte for byte" $
      inFolder $ \folder -> do
        let file name = folder </> name
            again (extension, more) = do
              let first = file ("first" ++ extension)
                  second = file ("second" ++ extension)
              codes <-
                mapM
                  run
                  [ ["render", "--width", "24", "--samples", "2", "--seed", "5", "--bloom", "0.1", "--tone-map", "agx", "-o", first] ++ more,
                    ["render", "--from", first, "-o", second]
                  ]
              same <- (==) <$> Bytes.readFile first <*> Bytes.readFile second
              pure (codes, same)
        mapM again [(".png", []), (".png", ["--bits", "16"]), (".jpg", ["--quality", "40"]), (".tif", ["--bits", "32"]), (".hdr", []), (".exr", ["--bits", "32"])]
          `shouldReturn` replicate 6 ([ExitSuccess, ExitSuccess], True)
    it "takes the scene of a picture of another format, and options on top" $
      inFolder $ \folder -> do
        let png = folder </> "a.png"
            exr = folder </> "b.exr"
        codes <- mapM run [["render", "--width", "24", "--bits", "16", "-o", png], ["render", "--from", png, "--seed", "9", "-o", exr]]
        codes `shouldBe` [ExitSuccess, ExitSuccess]
        text <- maybe "" (Characters.unpack . labelScene) . fileLabel <$> Bytes.readFile exr
        lines text `shouldContain` ["  seed: 9"]
        lines text `shouldContain` ["  width: 24"]
  describe "bad input" $ do
    fails 2 ["render", "--width", "many"]
    fails 2 ["render", "--no-such-option"]
    fails 2 []
    fails 3 ["render", "--width", "0"]
    fails 3 ["render", "--height", "-1"]
    fails 3 ["render", "--fov", "180"]
    fails 3 ["render", "--fov", "NaN"]
    fails 3 ["render", "--distance", "0.5"]
    fails 3 ["render", "--camera", "0,9,0", "--look-at", "0,0,0"]
    fails 3 ["render", "--preset", "nothing"]
    fails 2 ["render", "--threads", "0"]
    fails 2 ["render", "-o", "picture.bmp"]
    fails 2 ["render", "--bits", "9"]
    fails 2 ["render", "--quality", "0"]
    fails 2 ["render", "--from", "a.png", "b.yaml"]
    fails 3 ["render", "--from", "/no/such/picture.png"]
    fails 3 ["render", "--from", "/dev/null"]
    fails 3 ["render", "--bloom", "1.5"]
    fails 4 ["render", "--width", "16", "-o", "/no/such/folder/picture.png"]
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    fails code arguments =
      it (unwords ("blackhole" : arguments) ++ " exits with " ++ show code ++ " and writes nothing") $
        inFolder $ \folder -> do
          let output = ["--output=" ++ folder </> "picture.png" | arguments /= [], "-o" `notElem` arguments]
          run (arguments ++ output) `shouldReturn` ExitFailure code
          listDirectory folder `shouldReturn` []
    brightness picture x y =
      let PixelRGB8 r g b = pixelAt picture x y
          part c = fromIntegral c / 255
       in luminance (Radiance.Radiance (part r) (part g) (part b))
