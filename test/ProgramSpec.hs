-- | The program itself, as its user starts it.
module ProgramSpec (spec) where

import Codec.Picture
import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (concurrently)
import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import Data.List (isInfixOf, isSuffixOf)
import GHC.IO.Encoding (setFileSystemEncoding, setLocaleEncoding, utf8)
import System.Directory (findExecutable, listDirectory)
import System.Environment (getEnvironment)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Posix.Signals (sigKILL, signalProcess)
import System.Process
  ( CreateProcess (cwd, env, std_err),
    StdStream (NoStream),
    createProcess,
    getPid,
    proc,
    readCreateProcessWithExitCode,
    waitForProcess,
  )
import Test.Hspec

spec :: Spec
spec = before_ (setFileSystemEncoding utf8 >> setLocaleEncoding utf8) $ do
  it "writes the picture where it is called" $
    inFolder $ \folder -> do
      result <- program [] folder ["render", "--width", "32", "--samples", "1", "-o", "hole.png"]
      exitOf result `shouldBe` ExitSuccess
      listDirectory folder `shouldReturn` ["hole.png"]
      decoded <- decodePng <$> Bytes.readFile (folder </> "hole.png")
      fmap (dynamicMap (\image -> (imageWidth image, imageHeight image))) decoded
        `shouldBe` Right (32, 18)
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
  it
    "finishes an animation that is killed again and again, by two at once, with the bytes of \
    \one run"
    $ inFolder $ \folder -> do
      writeFile (folder </> "film.yaml") animation
      whole <- program [] folder ["animate", "film.yaml", "-o", "one/%d.png"]
      exitOf whole `shouldBe` ExitSuccess
      forM_ [20000, 90000 .. 440000] $ \microseconds ->
        killing folder microseconds ["animate", "film.yaml", "-o", "two/%d.png"]
      (a, b) <-
        concurrently
          (program [] folder ["animate", "film.yaml", "-o", "two/%d.png"])
          (program [] folder ["animate", "film.yaml", "-o", "two/%d.png"])
      map exitOf [a, b] `shouldBe` [ExitSuccess, ExitSuccess]
      (status, lacking, _) <- program [] folder ["animate", "--status", "two"]
      (status, lines lacking)
        `shouldBe` ( ExitSuccess,
                     ["two/%d.png: 6 frames, 6 done, 0 running, 0 missing, 0 stale, 0 damaged"]
                   )
      forM_ [0 .. 5 :: Int] $ \n -> do
        expected <- Bytes.readFile (folder </> "one" </> (show n ++ ".png"))
        Bytes.readFile (folder </> "two" </> (show n ++ ".png")) `shouldReturn` expected
      left <- listDirectory (folder </> "two" </> ".blackhole")
      filter (\name -> any (`isSuffixOf` name) [".claim", ".part"]) left `shouldBe` []
  where
    animation =
      unlines
        [ "image: {width: 96}",
          "sampling: {samples: 1}",
          "animation: {frames: 6, camera-path: {kind: orbit}}"
        ]
    killing folder microseconds arguments = do
      found <- findExecutable "blackhole"
      forM_ found $ \file -> do
        (_, _, _, process) <-
          createProcess (proc file arguments) {cwd = Just folder, std_err = NoStream}
        threadDelay microseconds
        victim <- getPid process
        forM_ victim (signalProcess sigKILL)
        waitForProcess process
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
            (proc file arguments)
              { cwd = Just folder,
                env = Just (settings ++ filter ((`notElem` map fst settings) . fst) inherited)
              }
            ""
