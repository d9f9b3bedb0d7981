{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE RankNTypes #-}

module BlackHole.Render.PixelArraySpec (spec) where

import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Control.Concurrent
import Control.Exception
import Control.Monad (forever, unless, void, when)
import Control.Monad.ST (ST)
import Control.Monad.ST.Unsafe (unsafeIOToST)
import Data.Bits (shiftL)
import Data.Foldable (for_)
import Data.IORef
import Data.List (nub)
import Data.Maybe (fromMaybe, isNothing, mapMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as MVector
import Data.Word (Word32)
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "says which back end it is" $ backendName `shouldSatisfy` (`elem` ["vector", "massiv"])

  describe "generateRows" $ do
    it "gives equal bytes for any number of workers" $ do
      let shape = shaped 31 40 3
      pictures <-
        traverse (\workers -> bits <$> generateRows workers silent shape unevenRow) workerCounts
      map (== uneven shape) pictures `shouldBe` map (const True) workerCounts

    prop "runs every row once, on zeros" . forAll ((,) <$> smallShape <*> elements workerCounts) $
      \(shape, workers) -> ioProperty . inTime $ do
        pixels <- generateRows workers silent shape $ \y row ->
          for_ [0 .. MVector.length row - 1] $ \i ->
            MVector.modify row (+ (y * shapeRowLength shape + i + 1)) i
        pixelArrayShape pixels `shouldBe` shape
        Vector.toList (toPixelVector pixels) `shouldBe` [1 .. shapeLength shape]

    it "makes a single pixel, a single row and a single column" $
      for_ [shaped 1 1 1, shaped 1 1 3, shaped 500 1 3, shaped 1 500 3] $ \shape ->
        for_ workerCounts $ \workers -> do
          pixels <- generateRows workers silent shape unevenRow
          bits pixels `shouldBe` uneven shape

    it "hands rows to any idle worker" . inTime $ do
      others <- newIORef (0 :: Int)
      allOthers <- newEmptyMVar
      void $
        generateRows (workersOf 2) silent (shaped 1 100 1) $ \y row -> do
          MVector.write row 0 (0 :: Float)
          unsafeIOToST $
            if y == 0
              then takeMVar allOthers
              else do
                finished <- atomicModifyIORef' others $ \n -> (n + 1, n + 1)
                when (finished == 99) $ putMVar allOthers ()

  describe "progress" $ do
    it "grows, ends with the height, and comes from one thread" . inTime $
      for_ workerCounts $ \workers -> do
        told <- newIORef []
        let tell count = myThreadId >>= \from -> modifyIORef told ((count, from) :)
        void $ generateRows workers tell (shaped 5 200 3) unevenRow
        (counts, tellers) <- unzip . reverse <$> readIORef told
        counts `shouldSatisfy` and . (zipWith (<) <*> drop 1) . (0 :)
        last (0 : counts) `shouldBe` 200
        length (nub tellers) `shouldBe` 1

    it "does not hold up the rows" . inTime $ do
      -- The listener goes on only after the last row. A row that waited for it would
      -- wait for ever.
      finished <- newIORef (0 :: Int)
      allFinished <- newEmptyMVar
      void $
        generateRows (workersOf 2) (const (readMVar allFinished)) (shaped 1 2000 3) $ \y row -> do
          unevenRow y row
          unsafeIOToST $ do
            count <- atomicModifyIORef' finished (\n -> (n + 1, n + 1))
            when (count == 2000) $ putMVar allFinished ()
      readIORef finished `shouldReturn` 2000

    it "passes its exceptions on and stops the rows" . stopsAllRows $ \beats ->
      generateRows (workersOf 3) (const (throwIO Overflow)) (shaped 1 100 1) (endless beats (== 0))
        `shouldThrow` (== Overflow)

  describe "exceptions" $ do
    it "of a row's pure code reach the caller" . inTime $
      for_ workerCounts $ \workers ->
        generateRows workers silent (shaped 4 50 1) (\y row -> MVector.set row (1 `div` (y - 17)))
          `shouldThrow` (== DivideByZero)

    it "of one row stop the others" . stopsAllRows $ \beats ->
      for_ workerCounts $ \workers ->
        generateRows workers silent (shaped 1 100 1) (endless beats (const False) `unlessRow` 0)
          `shouldThrow` (== DivideByZero)

    it "are survived: the next picture is whole" $ do
      let shape = shaped 4 50 3
      for_ workerCounts $ \workers -> do
        generateRows workers silent shape (unevenRow `unlessRow` 20)
          `shouldThrow` (== DivideByZero)
        pixels <- generateRows workers silent shape unevenRow
        bits pixels `shouldBe` uneven shape

  describe "interruption" $ do
    it "by a time limit stops all workers" . stopsAllRows $ \beats ->
      for_ workerCounts $ \workers -> do
        interrupted <-
          timeout 50000 $ generateRows workers silent (shaped 1 100 1) (endless beats (const False))
        isNothing interrupted `shouldBe` True

    it "reaches pure code" . inTime $ do
      interrupted <- timeout 50000 $ generateRows (workersOf 2) silent (shaped 1 100 1) endlessSum
      isNothing interrupted `shouldBe` True

    it "by another thread stops all workers before that thread goes on" . stopsAllRows $ \beats ->
      do
        ended <- newEmptyMVar
        caller <-
          forkIO $
            void (generateRows (workersOf 2) silent (shaped 1 100 1) (endless beats (const False)))
              `catch` (putMVar ended :: AsyncException -> IO ())
        threadDelay 20000
        killThread caller
        takeMVar ended `shouldReturn` ThreadKilled

  describe "vectors" $ do
    prop "go round and keep their memory" . forAll smallShape $ \shape -> ioProperty $ do
      let pixels =
            Vector.drop 2 (Vector.generate (2 + shapeLength shape) fromIntegral) ::
              Vector.Vector Float
          back = toPixelVector <$> fromPixelVector shape pixels
      back `shouldBe` Just pixels
      for_ back $ \same ->
        Vector.unsafeWith pixels $ \here ->
          Vector.unsafeWith same $ \there -> there `shouldBe` here

    prop "of another length are no picture" . forAll smallShape $ \shape ->
      all
        (isNothing . fromPixelVector shape . (`Vector.replicate` (0 :: Float)))
        [0, shapeLength shape - 1, shapeLength shape + 1]

silent :: Int -> IO ()
silent _ = pure ()

workersOf :: Int -> Workers
workersOf = fromMaybe oneWorker . workersFromCount

workerCounts :: [Workers]
workerCounts = mapMaybe workersFromCount [1, 2, 3, 7]

-- A shape of sides that are known to be positive.
shaped :: Int -> Int -> Int -> PixelShape
shaped width height channels =
  fromMaybe (throw (AssertionFailed "no such shape")) (pixelShape width height channels)

smallShape :: Gen PixelShape
smallShape = shaped <$> choose (1, 12) <*> choose (1, 12) <*> choose (1, 4)

-- A row's cost grows with the square of a scrambled row number.
unevenRow :: Int -> MVector s Float -> ST s ()
unevenRow y row = for_ [0 .. MVector.length row - 1] $ \i -> MVector.write row i (unevenValue y i)

unevenValue :: Int -> Int -> Float
unevenValue y i = go (((y * 7919) `mod` 41) ^ (2 :: Int)) (fromIntegral (y + 3 * i) / 7)
  where
    go :: Int -> Float -> Float
    go 0 !value = value
    go n !value = go (n - 1) (sin (value + fromIntegral i))

uneven :: PixelShape -> Vector.Vector Word32
uneven shape =
  Vector.unsafeCast . Vector.fromList $
    [ unevenValue y i
      | y <- [0 .. shapeHeight shape - 1],
        i <- [0 .. shapeRowLength shape - 1]
    ]

bits :: PixelArray Float -> Vector.Vector Word32
bits = Vector.unsafeCast . toPixelVector

-- Grows beyond a machine word, so that each addition asks for memory.
endlessSum :: Int -> MVector s Float -> ST s ()
endlessSum y row = go (1 `shiftL` 70 + toInteger y)
  where
    go !big
      | big < 0 = MVector.set row 0
      | otherwise = go (big + 1)

unlessRow :: (Int -> MVector s Float -> ST s ()) -> Int -> Int -> MVector s Float -> ST s ()
unlessRow fillRow bad y row
  | y == bad = MVector.set row (fromIntegral (1 `div` (y - bad)))
  | otherwise = fillRow y row

-- A row that counts up a shared number for ever, unless its number is let off.
endless :: IORef Int -> (Int -> Bool) -> Int -> MVector s Float -> ST s ()
endless beats letOff y _ =
  unsafeIOToST . unless (letOff y) . forever $
    threadDelay 1000 >> atomicModifyIORef' beats (\n -> (n + 1, ()))

-- Sees that nothing counts any more after the action.
stopsAllRows :: (IORef Int -> IO ()) -> IO ()
stopsAllRows action = inTime $ do
  beats <- newIORef 0
  action beats
  earlier <- readIORef beats
  threadDelay 30000
  readIORef beats `shouldReturn` earlier

-- What is not done after ten minutes hangs.
inTime :: IO a -> IO a
inTime action = timeout 600000000 action >>= maybe (throwIO (AssertionFailed "hangs")) pure
