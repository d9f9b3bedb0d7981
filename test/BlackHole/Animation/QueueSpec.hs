module BlackHole.Animation.QueueSpec (spec) where

import BlackHole.Animation.FrameName
import BlackHole.Animation.FrameStore
import BlackHole.Animation.Lease
import BlackHole.Animation.Queue
import BlackHole.Image.Digest
import Control.Concurrent (newEmptyMVar, putMVar, takeMVar, threadDelay)
import Control.Concurrent.Async (async, cancel, concurrently)
import Control.Exception (ErrorCall (..), throwIO)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.IORef
import Data.List (sort)
import System.Directory
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  it "makes what is missing, and nothing that is done" . inFolder $ \folder -> do
    store <- storeOf folder "one"
    (outcomes, made) <- working store good "v1" [0 .. 4]
    (map kind outcomes, made) `shouldBe` (replicate 5 'r', [0 .. 4])
    mapM (readFile . file folder) [0 .. 4] `shouldReturn` map (picture "v1") [0 .. 4]
    removeFile (file folder 3)
    (again, madeAgain) <- working store good "v1" [0 .. 4]
    (map kind again, madeAgain) `shouldBe` ("dddrd", [3])
  it "renders stale, changed and truncated frames again" . inFolder $ \folder -> do
    store <- storeOf folder "one"
    _ <- working store good "v1" [0 .. 5]
    writeFile (file folder 1) (map succ (picture "v1" 1))
    writeFile (file folder 2) "pic"
    removeFile (folder </> ".blackhole" </> "4.png.done")
    writeFile (folder </> ".blackhole" </> "5.png.done") "nonsense"
    mapM (\n -> frameState store n (scene "v1" n)) [1, 2, 4, 5]
      `shouldReturn` [Damaged, Damaged, Stale, Stale]
    (_, made) <- working store good "v1" [0 .. 5]
    made `shouldBe` [1, 2, 4, 5]
    (_, changed) <- working store good "v2" [0 .. 5]
    changed `shouldBe` [0 .. 5]
    mapM (readFile . file folder) [0 .. 5] `shouldReturn` map (picture "v2") [0 .. 5]
  it "goes on after a frame that fails, and makes it the next time" . inFolder $ \folder -> do
    store <- storeOf folder "one"
    let bad 1 = pure (Left "no light")
        bad 3 = throwIO (ErrorCall "on fire")
        bad n = good n
    (outcomes, _) <- working store bad "v1" [0 .. 4]
    outcomes `shouldSatisfy` \list -> [reason | Failed reason <- list] == ["no light", "on fire"]
    map kind outcomes `shouldBe` "rfrfr"
    (again, made) <- working store good "v1" [0 .. 4]
    (map kind again, made) `shouldBe` ("drdrd", [1, 3])
  it "shares the frames of one folder between two at once, each once" . inFolder $ \folder -> do
    one <- storeOf folder "one"
    two <- storeOf folder "two"
    let slow n = threadDelay 2000 >> good n
    ((a, madeA), (b, madeB)) <-
      concurrently (waiting one slow "v1" [0 .. 19]) (waiting two slow "v1" [0 .. 19])
    sort (madeA ++ madeB) `shouldBe` [0 .. 19]
    (filter (`notElem` "rd") (map kind a), filter (`notElem` "rd") (map kind b)) `shouldBe` ("", "")
    (null madeA, null madeB) `shouldBe` (False, False)
  it "leaves frames that another is at, and says whose they are" . inFolder $ \folder -> do
    one <- storeOf folder "one"
    two <- storeOf folder "two"
    _ <- takeLease (frameStoreLeases two) (frameLabel two 1)
    (outcomes, made) <- working one good "v1" [0 .. 2]
    (map kind outcomes, made) `shouldBe` ("rer", [0, 2])
    [fmap holderHost other | Elsewhere other <- outcomes] `shouldBe` [Just "two"]
  it "gives its lease back when it is interrupted" . inFolder $ \folder -> do
    store <- storeOf folder "one"
    begun <- newEmptyMVar
    let endless _ = putMVar begun () >> threadDelay 100000000 >> pure (Left "late")
    thread <- async (working store endless "v1" [0])
    takeMVar begun
    cancel thread
    other <- storeOf folder "two"
    takeLease (frameStoreLeases other) (frameLabel other 0) `shouldReturn` Leased Nothing
  it "leaves the frames, their records and the lock, and no parts" . inFolder $ \folder -> do
    store <- storeOf folder "one"
    _ <- working store good "v1" [0, 1]
    writeFrameList store [(n, scene "v1" n) | n <- [0 .. 2]]
    fmap sort (listDirectory folder) `shouldReturn` [".blackhole", "0.png", "1.png"]
    fmap sort (listDirectory (folder </> ".blackhole"))
      `shouldReturn` ["%d.png.film", "0.png.done", "1.png.done", "lock"]
    lists <- readFrameLists folder
    [(framePattern name, length frames) | (name, frames) <- lists]
      `shouldBe` [(folder </> "%d.png", 3)]
    map snd lists `shouldBe` [[(n, scene "v1" n) | n <- [0 .. 2]]]
  it "removes the lease of a process that was killed after it finished its frame" . inFolder $
    \folder -> do
      store <- storeOf folder "one"
      _ <- working store good "v1" [0, 1]
      _ <- takeLease (frameStoreLeases store) (frameLabel store 0)
      writeFile (folder </> ".blackhole" </> "0.png.one.4711.part") "half"
      (outcomes, _) <- working store good "v1" [0, 1]
      map kind outcomes `shouldBe` "dd"
      fmap sort (listDirectory (folder </> ".blackhole"))
        `shouldReturn` ["0.png.done", "1.png.done", "lock"]
  it "removes what a process left that was killed while it wrote the list" . inFolder $ \folder ->
    do
      store <- storeOf folder "one"
      _ <- takeLease (frameStoreLeases store) "%d.png.film"
      writeFile (folder </> ".blackhole" </> "%d.png.film.one.4711.part") "half"
      writeFrameList store [(0, scene "v1" 0)]
      fmap sort (listDirectory (folder </> ".blackhole")) `shouldReturn` ["%d.png.film", "lock"]
  it "removes the part that a dead holder has left" . inFolder $ \folder -> do
    dead <- storeOf folder "dead"
    one <- storeOf folder "one"
    _ <- takeLease (frameStoreLeases dead) (frameLabel dead 0)
    writeFile (folder </> ".blackhole" </> "0.png.dead.4711.part") "half"
    -- To be told from afar, an old lease must be older than the patience.
    store <- openFrameStore (frameStoreName one) (holder "one") (-1)
    (outcomes, _) <- working store good "v1" [0]
    map kind outcomes `shouldBe` "r"
    fmap sort (listDirectory (folder </> ".blackhole")) `shouldReturn` ["0.png.done", "lock"]
  where
    inFolder = withSystemTempDirectory "blackhole-spec"
    holder name = Holder name "boot" 4711 "1" Nothing
    storeOf folder name = case parseFrameName (folder </> "%d.png") of
      Right pattern' -> openFrameStore pattern' (holder name) 60
      Left reason -> throwIO (ErrorCall reason)
    file folder n = folder </> (show (n :: Int) ++ ".png")
    scene version n = digestText (version ++ show (n :: Int))
    picture version n = "picture " ++ digestHex (scene version n)
    good _ = pure (Right ())
    working store = through store LeaveOthers
    waiting store = through store WaitForOthers
    through store patience action version frames = do
      made <- newIORef []
      outcomes <-
        workThrough
          store
          patience
          (\_ _ -> pure ())
          (\_ _ -> pure ())
          (render made)
          [Job n (scene version n) | n <- frames]
      list <- readIORef made
      pure (map snd outcomes, reverse list)
      where
        render made (Job n _) = do
          result <- action n
          case result of
            Left reason -> pure (Left reason)
            Right () -> do
              atomicModifyIORef' made (\list -> (n : list, ()))
              pure (Right (Lazy.pack (picture version n)))
    kind outcome = case outcome of
      WasDone -> 'd'
      Rendered _ -> 'r'
      Elsewhere _ -> 'e'
      Failed _ -> 'f'
