-- | The library's example. README.md shows what follows the module's line.
module Example (main) where

import BlackHole
import System.Exit (die)

main :: IO ()
main = do
  scene <- orDie (change [("image.width", "64"), ("sampling.samples", "1")] defaultScene)
  film <- orDie =<< renderFilm (\rows -> putStrLn (show rows ++ " rows are done")) scene
  print (filmRadiance film 32 18)
  orDie =<< writeFilm "hole.png" scene film
  orDie =<< writeFilm "hole.exr" scene film
  where
    orDie = either (die . unlines) pure
