module BlackHole.Animation.LeaseSpec (spec) where

import BlackHole.Animation.Lease
import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (forConcurrently, wait, withAsync)
import Control.Monad (forM_, unless, when)
import Data.Time.Clock (addUTCTime)
import System.Directory
import System.FilePath ((</>))
import System.IO (IOMode (ReadWriteMode), openFile)
import System.IO.Temp (withSystemTempDirectory)
import System.Posix.Files (createNamedPipe)
import System.Posix.IO (FdOption (CloseOnExec), closeFd, handleToFd, setFdOption)
import System.Process (createProcess, getPid, proc, waitForProcess, withCreateProcess)
import System.Timeout (timeout)
import Test.Hspec

spec :: Spec
spec = do
  it "can be written and read again" $ do
    self <- currentHolder
    parseHolder (renderHolder self) `shouldBe` Just self
    let inJob = self {holderJob = Just ("17_3", 2)}
    parseHolder (renderHolder inJob) `shouldBe` Just inJob
  it "is given to one of many who ask at the same time" . inFolder $ \folder ->
    forM_ [1 .. 30 :: Int] $ \n -> do
      outcomes <- forConcurrently [1 .. 8] $ \i -> takeLease (folder (elsewhere i) 60) (show n)
      length [() | Leased _ <- outcomes] `shouldBe` 1
  it "is left to a holder who lives, and free again when he gives it back" . inFolder $ \folder ->
    do
      self <- currentHolder
      takeLease (folder self 60) "a" `shouldReturn` Leased Nothing
      takeLease (folder (elsewhere 1) 60) "a" `shouldReturn` HeldBy (Just self)
      liveHolder (folder (elsewhere 1) 60) "a" `shouldReturn` Just (Just self)
      releaseLease (folder self 60) "a"
      liveHolder (folder (elsewhere 1) 60) "a" `shouldReturn` Nothing
      takeLease (folder (elsewhere 1) 60) "a" `shouldReturn` Leased Nothing
  it "is not given back by anybody but its holder" . inFolder $ \folder -> do
    takeLease (folder (elsewhere 1) 60) "a" `shouldReturn` Leased Nothing
    releaseLease (folder (elsewhere 2) 60) "a"
    liveHolder (folder (elsewhere 2) 60) "a" `shouldReturn` Just (Just (elsewhere 1))
  it "leaves the folder unlocked to a program that was started meanwhile" . inFolder $ \path -> do
    self <- currentHolder
    let leases = path self 60
    -- A lease in a pipe keeps its reader, who holds the folder's lock, waiting.
    createNamedPipe (leaseFile leases "slow") 0o600
    writer <- handleToFd =<< openFile (leaseFile leases "slow") ReadWriteMode
    setFdOption writer CloseOnExec True
    withAsync (releaseLease leases "slow") $ \releasing -> do
      awaitFile (leaseFolderPath leases </> "lock")
      withCreateProcess (proc "sleep" ["100"]) $ \_ _ _ _ -> do
        closeFd writer
        wait releasing
        timeout 20000000 (releaseLease leases "other") `shouldReturn` Just ()
  it "is taken from a process of this machine that is gone" . inFolder $ \folder -> do
    self <- currentHolder
    gone <- deadProcess
    let dead = self {holderProcess = gone, holderStarted = "1"}
    takeLease (folder dead 60) "a" `shouldReturn` Leased Nothing
    takeLease (folder (self {holderStarted = "0"}) 60) "a" `shouldReturn` Leased (Just dead)
  it "is taken from a process whose number another one has now" . inFolder $ \folder -> do
    self <- currentHolder
    let earlier = self {holderStarted = "1"}
    takeLease (folder earlier 60) "a" `shouldReturn` Leased Nothing
    takeLease (folder self 60) "a" `shouldReturn` Leased (Just earlier)
  it "is taken from an earlier start of the same Slurm job, and of no other" . inFolder $ \folder ->
    do
      let start job n = (elsewhere n) {holderJob = Just (job, n)}
      takeLease (folder (start "17" 0) 60) "a" `shouldReturn` Leased Nothing
      takeLease (folder (start "18" 1) 60) "a" `shouldReturn` HeldBy (Just (start "17" 0))
      takeLease (folder (start "17" 1) 60) "a" `shouldReturn` Leased (Just (start "17" 0))
      -- Two processes of one start of a job work side by side.
      let beside = (start "17" 1) {holderHost = "host9"}
      takeLease (folder beside 60) "a" `shouldReturn` HeldBy (Just (start "17" 1))
      takeLease (folder (start "17" 0) 60) "a" `shouldReturn` HeldBy (Just (start "17" 1))
  it "is taken from another machine only when it has not been touched for a while" . inFolder $
    \folder -> do
      takeLease (folder (elsewhere 1) 60) "a" `shouldReturn` Leased Nothing
      age 50 (leaseFile (folder (elsewhere 1) 60) "a")
      takeLease (folder (elsewhere 2) 60) "a" `shouldReturn` HeldBy (Just (elsewhere 1))
      age 20 (leaseFile (folder (elsewhere 1) 60) "a")
      takeLease (folder (elsewhere 2) 60) "a" `shouldReturn` Leased (Just (elsewhere 1))
  it "is taken from another machine when it is dated in the future" . inFolder $ \folder -> do
    takeLease (folder (elsewhere 1) 60) "a" `shouldReturn` Leased Nothing
    age (-30) (leaseFile (folder (elsewhere 1) 60) "a")
    takeLease (folder (elsewhere 2) 60) "a" `shouldReturn` HeldBy (Just (elsewhere 1))
    age (-2000000000) (leaseFile (folder (elsewhere 1) 60) "a")
    takeLease (folder (elsewhere 2) 60) "a" `shouldReturn` Leased (Just (elsewhere 1))
  it "is kept by touching it" . inFolder $ \folder -> do
    let mine = folder (elsewhere 1) 0.5
    takeLease mine "a" `shouldReturn` Leased Nothing
    keepingAlive mine "a" $ do
      age 100 (leaseFile mine "a")
      old <- getModificationTime (leaseFile mine "a")
      awaitNewer old (leaseFile mine "a")
      takeLease (folder (elsewhere 2) 60) "a" `shouldReturn` HeldBy (Just (elsewhere 1))
  it "goes to one only of many who find it abandoned at the same time" . inFolder $ \folder ->
    forM_ [1 .. 30 :: Int] $ \n -> do
      takeLease (folder (elsewhere 0) 60) (show n) `shouldReturn` Leased Nothing
      age 100 (leaseFile (folder (elsewhere 0) 60) (show n))
      outcomes <- forConcurrently [1 .. 8] $ \i -> takeLease (folder (elsewhere i) 60) (show n)
      length [() | Leased _ <- outcomes] `shouldBe` 1
  it "counts as held when it is not legible, until it is old" . inFolder $ \folder -> do
    let mine = folder (elsewhere 1) 60
    writeFile (leaseFile mine "a") "\255"
    takeLease mine "a" `shouldReturn` HeldBy Nothing
    age 100 (leaseFile mine "a")
    takeLease mine "a" `shouldReturn` Leased Nothing
  it "leaves nothing but the lock behind" . inFolder $ \folder -> do
    let mine = folder (elsewhere 1) 60
    _ <- takeLease mine "a"
    _ <- takeLease (folder (elsewhere 2) 60) "a"
    releaseLease mine "a"
    listDirectory (leaseFolderPath mine) `shouldReturn` ["lock"]
  where
    inFolder check = withSystemTempDirectory "blackhole-spec" (check . LeaseFolder)
    elsewhere :: Int -> Holder
    elsewhere n = Holder ("host" ++ show n) "boot" 4711 "1" Nothing
    age seconds path =
      getModificationTime path >>= setModificationTime path . addUTCTime (negate seconds)
    awaitNewer old path = do
      touched <- getModificationTime path
      when (touched <= old) $ threadDelay 10000 >> awaitNewer old path
    awaitFile path = do
      exists <- doesFileExist path
      threadDelay 20000
      unless exists (awaitFile path)
    deadProcess = do
      (_, _, _, process) <- createProcess (proc "true" [])
      pid <- getPid process
      _ <- waitForProcess process
      pure (maybe 0 fromIntegral pid)
