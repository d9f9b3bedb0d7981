module BlackHole.Explore.FilesSpec (spec) where

import BlackHole.Explore.Files
import BlackHole.Explore.Message (Overwriting (..))
import BlackHole.Explore.PageFiles
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.Either (isLeft)
import System.Directory
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Posix.Files (createSymbolicLink)
import Test.Hspec

spec :: Spec
spec = do
  it "accepts plain names alone" $ do
    [nameFault [".yaml"] name | name <- ["a.yaml", "My scene.YAML", "häuser.yaml"]]
      `shouldBe` [Nothing, Nothing, Nothing]
    forM_
      [ "",
        "../a.yaml",
        "/a.yaml",
        "b/a.yaml",
        "b\\a.yaml",
        ".a.yaml",
        "-a.yaml",
        "a\n.yaml",
        "a.png",
        "a",
        replicate 300 'a' ++ ".yaml"
      ]
      $ \name ->
        nameFault [".yaml"] name `shouldSatisfy` (/= Nothing)
  it "keeps what exists unless asked, and follows no links" $
    inFolder $ \outside -> do
      writableFile [".yaml"] KeepFile "new.yaml" `shouldReturn` Right True
      writeFile "old.yaml" ""
      writableFile [".yaml"] KeepFile "old.yaml" `shouldReturn` Right False
      writableFile [".yaml"] ReplaceFile "old.yaml" `shouldReturn` Right True
      createSymbolicLink (outside </> "target.yaml") "link.yaml"
      writableFile [".yaml"] ReplaceFile "link.yaml" >>= (`shouldSatisfy` isLeft)
  it "reads only in its folder" $
    inFolder $ \outside -> do
      createDirectory "inner"
      writeFile ("inner" </> "sky.png") ""
      writeFile (outside </> "sky.png") ""
      createSymbolicLink outside "away"
      createSymbolicLink (outside </> "sky.png") "link.png"
      mapM readableFile ["inner/sky.png", "./inner/sky.png", "none.png"]
        `shouldReturn` [True, True, True]
      mapM
        readableFile
        [ "../outside/sky.png",
          outside </> "sky.png",
          "away/sky.png",
          "link.png",
          "inner/../../outside/sky.png"
        ]
        `shouldReturn` replicate 5 False
  it "has the page as it is in data/explore" $
    forM_ pageFiles $ \(name, _, contents) -> do
      let file = if Bytes.null name then "page.html" else Char8.unpack name
      expected <- Bytes.readFile ("data/explore" </> file)
      contents `shouldBe` expected
  where
    -- With a neighbouring folder.
    inFolder :: (FilePath -> IO a) -> IO a
    inFolder action = withSystemTempDirectory "blackhole" $ \folder -> do
      real <- canonicalizePath folder
      createDirectory (real </> "here")
      createDirectory (real </> "outside")
      withCurrentDirectory (real </> "here") (action (real </> "outside"))
