-- | The program itself, as its user starts it.
module ProgramSpec (spec) where

import Codec.Picture
import qualified Data.ByteString as Bytes
import Data.List (isInfixOf)
import GHC.IO.Encoding (setFileSystemEncoding, setLocaleEncoding, utf8)
import System.Directory (findExecutable, listDirectory)
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Process (CreateProcess (cwd, env), proc, readCreateProcessWithExitCode)
import Test.Hspec

spec :: Spec
spec = before_ (setFileSystemEncoding utf8 >> setLocaleEncoding utf8) $ do
  it "writes the picture where it is called" $
    inFolder $ \folder -> do
      result <- program [] folder ["render", "--width", "32", "--samples", "1", "-o", "hole.png"]
      exitOf result `shouldBe` ExitSuccess
      listDirectory folder `shouldReturn` ["hole.png"]
      decoded <- decodePng <$> Bytes.readFile (folder </> "hole.png")
      fmap (dynamicMap (\image -> (imageWidth image, imageHeight image))) decoded `shouldBe` Right (32, 18)
  it "draws a picture in letters where there is no terminal, and writes no file" $
    inFolder $ \folder -> do
      (code, text, _) <- program [("LC_ALL", "C")] folder ["render", "--preview", "--samples", "1"]
      code `shouldBe` ExitSuccess
      listDirectory folder `shouldReturn` []
      (length (lines text), map length (lines text)) `shouldSatisfy` \(count, widths) ->
        null text || (count == 22 && all (== 80) widths)
  it "repeats an argument in letters outside ASCII where no locale is set" $
    inFolder $ \folder -> do
      (code, _, message) <- program [("LC_ALL", "C")] folder ["render", "--preset", "größe"]
      code `shouldNotBe` ExitFailure 1
      message `shouldSatisfy` ("größe" `isInfixOf`)
      length (lines message) `shouldBe` 1
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    exitOf (code, _, _) = code
    -- Whoever starts the tests puts the program on the PATH; without it there is
    -- nothing to test.
    program settings folder arguments = do
      found <- findExecutable "blackhole"
      inherited <- getEnvironment
      case found of
        Nothing -> pendingWith "blackhole is not on the PATH" >> pure (ExitSuccess, "", "")
        Just file ->
          readCreateProcessWithExitCode
            (proc file arguments) {cwd = Just folder, env = Just (settings ++ filter ((`notElem` map fst settings) . fst) inherited)}
            ""
