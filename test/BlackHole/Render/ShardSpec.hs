module BlackHole.Render.ShardSpec (spec) where

import BlackHole.Render.Shard
import Data.Either (isLeft)
import Data.List (sort)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "reads I/N and nothing else" $ do
    map parseShard ["1/1", "3/7"] `shouldBe` [Just (Shard 1 1), Just (Shard 3 7)]
    map
      parseShard
      ["0/3", "4/3", "-1/3", "1", "1/", "/3", "1/2/3", "a/b", "1 /2", "99999999/99999999"]
      `shouldBe` replicate 10 Nothing
  prop "the shards of a list are all of it, once, and as long as each other but for one" $
    forAll ((,) <$> choose (1, 9) <*> choose (0, 60)) $ \(n, size) ->
      let parts = [takeShard (Shard i n) [1 .. size :: Int] | i <- [1 .. n]]
          lengths = map length parts
       in sort (concat parts) === [1 .. size] .&&. maximum lengths - minimum lengths <= 1
  prop "the bands of a picture follow each other and are as high as each other but for one row" $
    forAll ((,) <$> choose (1, 40) <*> choose (1, 5000)) $ \(n, height) ->
      let bands = [shardRows (Shard i n) height | i <- [1 .. n]]
       in concat [[from .. from + rows - 1] | (from, rows) <- bands] === [0 .. height - 1]
            .&&. maximum (map snd bands) - minimum (map snd bands) <= 1
  it "takes a Slurm task's part from the array's variables" $ do
    slurm [("ID", "3"), ("MIN", "1"), ("MAX", "8"), ("COUNT", "8"), ("STEP", "1")]
      `shouldBe` Right (Shard 3 8)
    slurm [("ID", "0"), ("MIN", "0"), ("MAX", "3"), ("COUNT", "4")] `shouldBe` Right (Shard 1 4)
    slurm [("ID", "7"), ("MIN", "1"), ("MAX", "9"), ("COUNT", "5"), ("STEP", "2")]
      `shouldBe` Right (Shard 4 5)
  it "gives all of it to a single task, which is how a lost one is submitted again" $
    slurm [("ID", "7"), ("MIN", "7"), ("MAX", "7"), ("COUNT", "1")] `shouldBe` Right (Shard 1 1)
  it "refuses gaps and what is no array" $ do
    slurm [("ID", "3"), ("MIN", "1"), ("MAX", "7"), ("COUNT", "3")] `shouldSatisfy` isLeft
    slurm [("ID", "x"), ("MIN", "1"), ("MAX", "7"), ("COUNT", "7")] `shouldSatisfy` isLeft
    slurm [] `shouldSatisfy` isLeft
  where
    slurm settings =
      slurmShard (\name -> lookup name [("SLURM_ARRAY_TASK_" ++ n, v) | (n, v) <- settings])
