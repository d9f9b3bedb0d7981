module BlackHole.Image.AtomicFileSpec (spec) where

import BlackHole.Image.AtomicFile
import Control.Concurrent (forkIO, killThread, newEmptyMVar, putMVar, takeMVar, threadDelay)
import Control.Exception (ArithException (DivideByZero), finally, throw)
import Control.Monad (forever, (>=>))
import qualified Data.ByteString as Strict
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (for_)
import Data.List (isInfixOf)
import System.Directory
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.IO.Unsafe (unsafeInterleaveIO)
import System.Info (os)
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck.Monadic (monadicIO, run)

spec :: Spec
spec = do
  describe "writeFileAtomically" $ do
    modifyMaxSuccess (const 20) . prop "writes the bytes and nothing else" $ \words8 ->
      monadicIO . run . inFolder $ \folder -> do
        let target = folder </> "hole.png"
        writeFileAtomically target (Lazy.pack words8) `shouldReturn` Right ()
        Strict.readFile target `shouldReturn` Strict.pack words8
        listDirectory folder `shouldReturn` ["hole.png"]

    it "takes what an action writes, and nothing of an action that fails" . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      writeAtomically target (\handle -> Strict.hPut handle former >> Strict.hPut handle former)
        `shouldReturn` Right ()
      Strict.readFile target `shouldReturn` former <> former
      failed <-
        writeAtomically
          target
          (\handle -> Strict.hPut handle (Lazy.toStrict latter) >> ioError (userError "no more"))
      either renderWriteProblem (const "") failed `shouldSatisfy` ("no more" `isInfixOf`)
      Strict.readFile target `shouldReturn` former <> former
      listDirectory folder `shouldReturn` ["hole.png"]

    it "replaces a file" . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      Strict.writeFile target former
      writeFileAtomically target latter `shouldReturn` Right ()
      Strict.readFile target `shouldReturn` Lazy.toStrict latter
      listDirectory folder `shouldReturn` ["hole.png"]

    it "shows the former file until the new one is complete" . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      Strict.writeFile target former
      seen <- newEmptyMVar
      late <- unsafeInterleaveIO $ do
        Strict.readFile target >>= putMVar seen
        pure (Lazy.toStrict latter)
      writeFileAtomically target (Lazy.fromChunks [Strict.replicate 100000 7, late])
        `shouldReturn` Right ()
      takeMVar seen `shouldReturn` former

    it "gives a new file the permissions of any other new file" . inFolder $ \folder -> do
      writeFile (folder </> "plain") ""
      writeFileAtomically (folder </> "hole.png") latter `shouldReturn` Right ()
      plain <- getPermissions (folder </> "plain")
      getPermissions (folder </> "hole.png") `shouldReturn` plain

    it "keeps the permissions of a file it replaces" . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      writeFile target ""
      getPermissions target >>= setPermissions target . setOwnerExecutable True
      earlier <- getPermissions target
      writeFileAtomically target latter `shouldReturn` Right ()
      getPermissions target `shouldReturn` earlier

    it "leaves the former file when the bytes can't be computed" . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      Strict.writeFile target former
      writeFileAtomically target (Lazy.fromChunks [Strict.replicate 100000 7, throw DivideByZero])
        `shouldThrow` (== DivideByZero)
      Strict.readFile target `shouldReturn` former
      listDirectory folder `shouldReturn` ["hole.png"]

    it "leaves nothing behind when it is interrupted" . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      begun <- newEmptyMVar
      ended <- newEmptyMVar
      never <- unsafeInterleaveIO $ putMVar begun () >> forever (threadDelay 1000000)
      writer <-
        forkIO $
          (writeFileAtomically target (Lazy.fromChunks [former, never]) >>= print)
            `finally` putMVar ended ()
      takeMVar begun
      listDirectory folder >>= (`shouldSatisfy` all (".part" `isInfixOf`))
      killThread writer
      takeMVar ended
      listDirectory folder `shouldReturn` []

    it "takes a name as long as the file system allows" . inFolder $ \folder -> do
      let name = replicate 255 'x'
      writeFileAtomically (folder </> name) latter `shouldReturn` Right ()
      listDirectory folder `shouldReturn` [name]

  describe "symbolic links" $ do
    it "replaces what a chain of links leads to" . onPosix . inFolder $ \folder -> do
      createDirectory (folder </> "pictures")
      Strict.writeFile (folder </> "pictures" </> "hole.png") former
      createFileLink ("pictures" </> "hole.png") (folder </> "second")
      createFileLink "second" (folder </> "first")
      writeFileAtomically (folder </> "first") latter `shouldReturn` Right ()
      pathIsSymbolicLink (folder </> "first") `shouldReturn` True
      pathIsSymbolicLink (folder </> "second") `shouldReturn` True
      Strict.readFile (folder </> "pictures" </> "hole.png") `shouldReturn` Lazy.toStrict latter

    it "makes the file that a link leads to" . onPosix . inFolder $ \folder -> do
      createFileLink "hole.png" (folder </> "link")
      writeFileAtomically (folder </> "link") latter `shouldReturn` Right ()
      Strict.readFile (folder </> "hole.png") `shouldReturn` Lazy.toStrict latter

    it "refuses links that lead in a circle" . onPosix . inFolder $ \folder -> do
      createFileLink "b" (folder </> "a")
      createFileLink "a" (folder </> "b")
      refused (folder </> "a") "symbolic links"

  describe "devices" $ do
    it "are written to, not replaced" . onPosix $ do
      writeFileAtomically "/dev/null" latter `shouldReturn` Right ()
      checkWritable "/dev/null" `shouldReturn` Right ()
      doesFileExist "/dev/null" `shouldReturn` True
      Strict.readFile "/dev/null" `shouldReturn` Strict.empty

    it "report a full disk" . onSystem ["linux"] $
      writeFileAtomically "/dev/full" latter
        >>= (`shouldSatisfy` either (("No space" `isInfixOf`) . renderWriteProblem) (const False))

  describe "checkWritable" $ do
    it "leaves no file" . inFolder $ \folder -> do
      checkWritable (folder </> "hole.png") `shouldReturn` Right ()
      listDirectory folder `shouldReturn` []

    it "leaves an existing file alone" . inFolder $ \folder -> do
      Strict.writeFile (folder </> "hole.png") former
      checkWritable (folder </> "hole.png") `shouldReturn` Right ()
      Strict.readFile (folder </> "hole.png") `shouldReturn` former

  describe "problems, found before and at writing" $ do
    it "an empty path" $ refusedWith EmptyPath ""

    it "a folder" . inFolder $ \folder -> refusedWith (TargetIsFolder folder) folder

    it "a missing folder" . inFolder $ \folder -> do
      let target = folder </> "missing" </> "hole.png"
      refusedWith (FolderMissing target (folder </> "missing")) target
      listDirectory folder `shouldReturn` []

    it "a file in place of the folder" . inFolder $ \folder -> do
      Strict.writeFile (folder </> "file") former
      refused (folder </> "file" </> "hole.png") ""
      listDirectory folder `shouldReturn` ["file"]

    it "a name that is too long" . inFolder $ \folder -> do
      refused (folder </> replicate 300 'x') ""
      listDirectory folder `shouldReturn` []

    it "a name that the system would cut off" . inFolder $ \folder -> do
      refused (folder </> "hole\0.png") "NUL"
      listDirectory folder `shouldReturn` []

    it "a folder one may not write to" . onPosix . inFolder $ \folder -> do
      let closed = folder </> "closed"
      createDirectory closed
      withoutWriting closed $ do
        refused (closed </> "hole.png") closed
        listDirectory closed `shouldReturn` []

    it "a write-protected file" . onPosix . inFolder $ \folder -> do
      let target = folder </> "hole.png"
      Strict.writeFile target former
      withoutWriting target $ do
        refusedWith (TargetIsProtected target) target
        Strict.readFile target `shouldReturn` former

  describe "renderWriteProblem" . it "keeps to one line" $
    for_
      [ EmptyPath,
        TargetIsFolder "a\nb",
        TargetIsProtected "a\nb",
        FolderMissing "a\nb/c" "a\nb",
        FolderNotWritable "a\nb/c" "a\nb" "Permission denied",
        SystemRefused "a\nb" "No space left on device"
      ]
      $ (`shouldSatisfy` ((== 1) . length . lines)) . renderWriteProblem

former :: Strict.ByteString
former = Char8.pack "former"

latter :: Lazy.ByteString
latter = Lazy.fromStrict (Char8.pack "latter")

inFolder :: (FilePath -> IO ()) -> IO ()
inFolder = deadline . withSystemTempDirectory "blackhole-spec"
  where
    -- What is not done after ten minutes hangs.
    deadline = timeout 600000000 >=> (`shouldBe` Just ())

refusedWith :: WriteProblem -> FilePath -> Expectation
refusedWith problem path = do
  checkWritable path `shouldReturn` Left problem
  writeFileAtomically path latter `shouldReturn` Left problem

-- Refused with a message that names the path, apart from odd characters, and
-- holds the given words.
refused :: FilePath -> String -> Expectation
refused path clue = do
  checkWritable path >>= (`shouldSatisfy` named)
  writeFileAtomically path latter >>= (`shouldSatisfy` named)
  where
    named = either (tells . renderWriteProblem) (const False)
    tells message = all (`isInfixOf` message) [takeWhile (/= '\0') path, clue]

-- The superuser may write anywhere, so that there is nothing to see then.
withoutWriting :: FilePath -> IO () -> IO ()
withoutWriting path action = do
  earlier <- getPermissions path
  setPermissions path (setOwnerWritable False earlier)
  obeyed <- not . writable <$> getPermissions path
  (if obeyed then action else pendingWith "runs as a user who may write anywhere")
    `finally` setPermissions path earlier

onPosix :: IO () -> IO ()
onPosix action
  | os == "mingw32" = pendingWith "not on Windows"
  | otherwise = action

onSystem :: [String] -> IO () -> IO ()
onSystem systems action
  | os `elem` systems = action
  | otherwise = pendingWith ("only on " ++ unwords systems)
