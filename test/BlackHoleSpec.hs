module BlackHoleSpec (spec) where

import BlackHole
import qualified BlackHole.Cli.Run as Program
import Control.Exception (bracket_)
import qualified Data.ByteString as Bytes
import Data.List (isInfixOf)
import qualified Example
import GHC.IO.Encoding (setLocaleEncoding, utf8)
import GHC.IO.Handle (hDuplicate, hDuplicateTo)
import System.Directory (listDirectory, withCurrentDirectory)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO (IOMode (WriteMode), hFlush, stdout, withFile)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = before_ (setLocaleEncoding utf8) $ do
  it "its example runs, and is what README.md shows" $ do
    (_, shown) <- break (== "import BlackHole") . lines <$> readFile "test/Example.hs"
    readme <- readFile "README.md"
    length shown `shouldSatisfy` (<= 15)
    readme `shouldSatisfy` isInfixOf (unlines (["```haskell"] ++ shown ++ ["```"]))
    inFolder $ \folder -> do
      said <- withCurrentDirectory folder (outputOf (folder </> "said") Example.main)
      map last' (lines said) `shouldSatisfy` \ends -> "done" `elem` ends
      said `shouldSatisfy` isInfixOf "Just (Radiance"
      listDirectory folder >>= (`shouldMatchList` ["hole.png", "hole.exr", "said"])
  it "writes the bytes that the program writes" $
    inFolder $ \folder -> do
      let file name = folder </> name
      Right scene <-
        pure
          ( change
              [("image.width", "40"), ("sampling.samples", "1"), ("camera.fov", "70")]
              defaultScene
          )
      renderToFile (file "a.png") scene `shouldReturn` Right ()
      Program.run
        ["render", "--width", "40", "--samples", "1", "--fov", "70", "--quiet", "-o", file "b.png"]
        `shouldReturn` ExitSuccess
      ours <- Bytes.readFile (file "a.png")
      Bytes.readFile (file "b.png") `shouldReturn` ours
      Bytes.writeFile (file "scene.yaml") . Bytes.pack . map (fromIntegral . fromEnum)
        . filter (< '\x80')
        $ printScene scene
      loadScene (file "scene.yaml") `shouldReturn` Right scene
  it "tells everything that is wrong with settings at once" $ do
    let wrong pairs = either length (const 0) (change pairs defaultScene)
    wrong [("image.widht", "3"), ("disk.opacity", "much"), ("image.height", "3")] `shouldBe` 2
    wrong [("camera.inclination", "200"), ("image.width", "0")] `shouldBe` 2
    wrong [("image.width", "0"), ("image.width", "16")] `shouldBe` 0
    either head' (const "") (change [("image.widht", "3")] defaultScene)
      `shouldSatisfy` isInfixOf "image.width"
    Right empty <- pure (change [("disk.present", "false")] defaultScene)
    either head' (const "") (change [("disk.opacity", "2")] empty)
      `shouldSatisfy` isInfixOf "no effect"
  it "refuses a file without a known extension before it renders" $
    renderToFile "/no/such/place/hole.bmp" defaultScene
      >>= (`shouldSatisfy` either (any ("hole.bmp" `isInfixOf`)) (const False))
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    last' line = if null (words line) then "" else last (words line)
    head' lines' = concat (take 1 lines')

-- | What an action prints, by way of a file.
outputOf :: FilePath -> IO () -> IO String
outputOf file action = do
  hFlush stdout
  kept <- hDuplicate stdout
  withFile file WriteMode $ \handle ->
    bracket_ (hDuplicateTo handle stdout) (hFlush stdout >> hDuplicateTo kept stdout) action
  readFile file
