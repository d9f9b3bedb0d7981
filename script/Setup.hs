-- | The package's Cabal set-up program, for building with nothing but GHC; see
-- @lib.sh@.
module Main (main) where

import Distribution.Simple (defaultMain)

main :: IO ()
main = defaultMain
